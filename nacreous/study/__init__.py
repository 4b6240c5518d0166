"""The study: samples before people's eyes, two at a time.

`nacreous.study.design` says what is shown and asked and freezes it; `nacreous.study.plan` says in
which order one participant sees it; `nacreous.study.store` keeps their answers.
"""

import lazy_loader

# Loaded when first asked for: a study needs neither its store nor its results to be designed.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
