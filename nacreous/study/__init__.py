"""The study: samples before people's eyes, two at a time.

`nacreous.study.design` says what is shown and asked and freezes it; `nacreous.study.plan` says in
which order one participant sees it; `nacreous.study.store` keeps their answers.
"""
