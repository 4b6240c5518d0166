"""Messages in the command's words: argument names become options, and nobody's own words do."""

import pytest

from nacreous.commands.spoken import spoken
from nacreous.problem import InputError


def said(message: str) -> str:
    with pytest.raises(InputError) as refusal, spoken("a file.csv"):
        raise InputError(message)
    return str(refusal.value)


@pytest.mark.parametrize("name", ["language", "question", "order=False", "prior=1.0", "is True;"])
@pytest.mark.parametrize(
    "message",
    [
        '"{}" is no group of these answers; allowed: "sex"',
        "a file.csv: row 2: chosen is '{}'; allowed: 'a'",
        'a file.csv: column "{}" holds "{}"; allowed: one',
    ],
)
def test_what_somebody_wrote_stays_as_it_is(name: str, message: str) -> None:
    message = message.replace("{}", name)
    assert said(message) == message


@pytest.mark.parametrize(
    ("message", "spoken_as"),
    [
        ("group is 'prior=1.0'; allowed: none", "--group is 'prior=1.0'; allowed: none"),
        ("question is 'None'; allowed: None", "--question is None; allowed: none"),
        ("order is True; allowed: order=False", "--order is given; allowed: no --order"),
        (
            "people's \"prior=1\" is left; name it by left='stim l', chosen=NAME",
            "people's \"prior=1\" is left; name it by --column 'left=stim l' --column chosen=NAME",
        ),
    ],
)
def test_arguments_become_options_outside_quotes_alone(message: str, spoken_as: str) -> None:
    assert said(message) == spoken_as
