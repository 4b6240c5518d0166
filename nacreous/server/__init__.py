"""The study's server: pages for participants and experimenters, and the HTTP under them.

One process serves one frozen study. Everything that counts is decided in `nacreous.study`; this
room reads requests, says who may, and tells what went wrong.
"""
