"""The one way Nacreous says that something from outside cannot be used."""


class InputError(ValueError):
    """A value from outside (file, argument, picture) that cannot be used.

    The message is one line for the person who gave the value: which quantity, its value, what is
    allowed, and where it stands (file and key). The command line prints it and ends with code 2.

    >>> raise InputError("pearl.toml: nacre.protein_nm is -3; allowed: 0 to 200")
    Traceback (most recent call last):
    nacreous.problem.InputError: pearl.toml: nacre.protein_nm is -3; allowed: 0 to 200
    """
