"""The one way Nacreous says that something from outside cannot be used."""

from nacreous.printable import printable_lines


class InputError(ValueError):
    """A value from outside (file, argument, picture) that cannot be used.

    The message is one line for the person who gave the value: which quantity, its value, what is
    allowed, and where it stands (file and key). The command line prints it and ends with code 2.
    Control characters of what it quotes are shown by their numbers, in tracebacks too.

    >>> raise InputError("pearl.toml: nacre.protein_nm is -3; allowed: 0 to 200")
    Traceback (most recent call last):
    nacreous.problem.InputError: pearl.toml: nacre.protein_nm is -3; allowed: 0 to 200
    """

    def __str__(self) -> str:
        """The message as a terminal, a log and a page can show it."""
        return printable_lines(super().__str__())
