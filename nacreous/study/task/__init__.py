"""What is asked of people, as an open set: each task a folder here, `pair` the first.

`task.py` says what a task is, `tasks.py` which there are, `counting.py` which answers count. The
plan orders trials, and the store keeps responses, without a look into either.
"""
