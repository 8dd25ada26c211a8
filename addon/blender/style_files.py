"""Style files: those that ship, and the user's own, in the extension's folder for them. Their names differ."""

import re
from functools import lru_cache
from pathlib import Path

import bpy

from .. import style
from .line_kinds import definitions
from .preferences import ADDON


def user_folder(create=False):
    """Where the user's styles are. ValueError where the add-on was not installed as an extension."""
    return Path(bpy.utils.extension_path_user(ADDON, path="styles", create=create))


def user_names():
    try:
        return sorted(path.stem for path in user_folder().glob("*.json"))
    except ValueError:
        return []


@lru_cache(maxsize=1)
def shipped_names():
    return tuple(style.names())


def names():
    """Those that ship, then the user's."""
    return [*shipped_names(), *(name for name in user_names() if name not in shipped_names())]


def load(name):
    """The Style of that name; StyleError says what is wrong."""
    if name in shipped_names():
        return style.load(name, definitions() or None)
    if name not in user_names():
        raise style.StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return style.read(user_folder() / f"{name}.json", definitions() or None)


def file_name(title):
    """A name for a user's style that is safe as that of a file. StyleError where there is none."""
    name = re.sub(r"\W+", "_", title, flags=re.ASCII).strip("_").lower()
    if not name:
        raise style.StyleError("a style's name needs letters or digits")
    if name in shipped_names():
        raise style.StyleError(f"'{name}' ships with Fovea; save the style by another name")
    return name


def save(name, wanted):
    """Writes a Style to the user's folder, over one that has the name: its path."""
    path = user_folder(create=True) / f"{name}.json"
    write(path, wanted)
    return path


def write(path, wanted):
    """All of the file or, where that fails, nothing of it."""
    fresh = Path(path).with_suffix(".json.new")
    fresh.write_text(style.dump(wanted), encoding="utf-8")
    fresh.replace(path)


def delete(name):
    (user_folder() / f"{name}.json").unlink()


def picture(name):
    """The thumbnail of a style, or None."""
    path = style.FOLDER / f"{name}.jpg"
    return path if path.exists() else None
