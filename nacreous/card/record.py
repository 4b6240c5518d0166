"""Cards for machines."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nacreous.card.making import command

if TYPE_CHECKING:
    from nacreous.card.card import Card
    from nacreous.card.factor import Factor

__all__ = ["record"]


def record(cards: Sequence[Card], output: str | None = None, language: str = "en") -> str:
    """All factors as JSON, words in both languages; null where there is no word or error.

    output, language: of the page, for the command that makes it again.
    """
    held = {
        "virtual": True,
        "graded_by": "the table of nacreous.trade, applied to numbers; no laboratory",
        "command": command(cards, language, output or "card.html"),
        "cards": [_card(card) for card in cards],
    }
    return json.dumps(held, ensure_ascii=False, indent=2) + "\n"


def _card(card: Card) -> dict[str, object]:
    return {
        "pearl": card.pearl.name,
        "model": card.pearl.model,
        "scene": card.scene_name,
        "size": card.size,
        "samples": card.samples,
        "type": card.culture,
        "factors": [_factor(factor) for factor in card.factors],
        "file": card.pearl.to_toml(),
    }


def _factor(factor: Factor) -> dict[str, object]:
    word = factor.word
    return {
        "factor": factor.name,
        "word": None if word is None else {"en": word.en, "ja": word.ja},
        "note": factor.note or None,
        "numbers": [
            {
                "quantity": one.quantity,
                "value": one.value,
                "error": one.error,
                "unit": one.unit,
                "from": one.origin,
                "key": one.key or None,
            }
            for one in factor.figures
        ],
    }
