"""Old names of the room, kept for one version."""

import pytest

from nacreous.study import outcome, results


def test_an_old_name_still_leads_there_and_says_the_new_one():
    with pytest.warns(DeprecationWarning, match="is now nacreous.study.results"):
        assert outcome.report is results.report


def test_an_old_module_has_no_other_name():
    with pytest.raises(AttributeError, match="has no attribute 'rapport'"):
        _ = outcome.rapport
