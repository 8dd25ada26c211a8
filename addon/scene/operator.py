# SPDX-License-Identifier: GPL-3.0-or-later
"""What the add-on's operators have in common."""

from .. import native, style
from .problem import CannotDraw

TOLD = (CannotDraw, native.Unavailable, style.StyleError)  # errors whose words are for the user


class Operator:
    """One that can be undone, says why it cannot be called now, and reports errors as one sentence."""

    bl_options = {"REGISTER", "UNDO"}
    errors, level = TOLD, "ERROR"  # those that `act` may raise, and how grave they are

    @classmethod
    def poll(cls, context):
        reason = cls.hindrance(context)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    @classmethod
    def hindrance(cls, context):
        """Why it cannot be called in a context, or None."""

    def execute(self, context):
        try:
            self.act(context)
        except self.errors as error:
            self.report({self.level}, self.sentence(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    @staticmethod
    def sentence(error):
        return str(error)
