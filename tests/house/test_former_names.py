"""Former names of public things lead to the present ones for one version, and say so."""

from importlib import import_module

import pytest

FORMER = [
    ("nacreous.body", "of_pearl", "reflectance_of_body"),
    ("nacreous.iridescence", "illuminant", "illuminant_model"),
    ("nacreous.scaling", "Design", "PairDesign"),
    ("nacreous.scaling", "Group", "Grouping"),
    ("nacreous.scaling", "Study", "Analysis"),
    ("nacreous.scaling", "study", "analyse"),
    ("nacreous.texture", "of_pearl", "texture_of"),
]


@pytest.mark.parametrize(("module", "former", "present"), FORMER)
def test_a_former_name_leads_to_the_present_one_and_warns_its_user(module, former, present):
    room = import_module(module)
    with pytest.warns(
        DeprecationWarning, match=f"{module}.{former} is now {module}.{present}"
    ) as told:
        assert getattr(room, former) is getattr(room, present)
    assert told[0].filename == __file__


@pytest.mark.parametrize("module", sorted({module for module, _, _ in FORMER}))
def test_an_unknown_name_is_none(module):
    with pytest.raises(AttributeError, match=r"attribute '?unknown'?"):
        _ = import_module(module).unknown
