"""The words of a trial run, where no person's answer will be kept as data."""

from __future__ import annotations

CONSENT = {
    "en": "This is a demonstration. Your answers are kept on this computer only, and are not used "
    "in any research. You can stop at any time by closing the page.",
    "ja": "これはデモンストレーションです。回答はこのコンピューターにのみ保存され、"
    "研究には使用されません。ページを閉じれば、いつでも終了できます。",
}
INSTRUCTIONS = {
    "en": "You will see two pictures side by side. Choose the one that answers the question. "
    "There is no right or wrong answer.",
    "ja": "二つの画像が並んで表示されます。質問に合うほうを一つ選んでください。"
    "正解や不正解はありません。",
}
