# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of the add-on's operators."""

from .. import native, style
from .problem import CannotDraw

TOLD = (CannotDraw, native.Unavailable, native.Refused, style.StyleError)  # errors whose messages are for the user


class Operator:
    """An operator with undo that explains why it is unavailable, and reports errors of `act` as one sentence."""

    bl_options = {"REGISTER", "UNDO"}
    errors, level = TOLD, "ERROR"  # exceptions from `act` that are reported, and the report's level

    @classmethod
    def poll(cls, context):
        reason = cls.hindrance(context)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    @classmethod
    def hindrance(cls, context):
        """Why the operator is unavailable in a context, for the poll message; None if it is available."""

    def execute(self, context):
        try:
            self.act(context)
        except self.errors as error:
            self.report({self.level}, self.sentence(error))
            return {"CANCELLED"}
        except MemoryError:
            self.report({"ERROR"}, "Memory is too small for this: hide or simplify the largest objects")
            return {"CANCELLED"}
        return {"FINISHED"}

    @staticmethod
    def sentence(error):
        return str(error)
