"""The word after `--param`."""

import argparse


def parse(text):
    """NAME=NUMBER as (name, number); which names and numbers there are is for the line definition to say."""
    name, _, value = text.partition("=")
    try:
        return name, float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=NUMBER") from None
