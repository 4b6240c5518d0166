"""A frozen study and its store together: who enters, what they see, which answers are theirs."""

from nacreous.study.running.running import Running

__all__ = ["Running"]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
