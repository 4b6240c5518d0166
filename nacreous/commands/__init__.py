"""The commands, one module each.

A command module has `add_parser(subparsers)`, which describes the command and sets
`run=run`, and `run(args) -> int`, which does the work and gives the exit code. Whatever is slow to
import is imported inside `run`, so that `nacreous --help` stays quick.
"""
