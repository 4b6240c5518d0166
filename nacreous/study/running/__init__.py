"""A frozen study and its store together: who enters, what they see, which answers are theirs."""

from nacreous.study.running.running import Running

__all__ = ["Running"]
