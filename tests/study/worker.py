"""Fifty people who answer a hundred trials each, all at once, in a process that can be killed.

    python worker.py PLACE ACKNOWLEDGED STUDY

Every acknowledged answer is a line in the file ACKNOWLEDGED, written after the receipt came. Who is
told that the machine refuses tries again, as a browser would.
"""

import os
import sys
import threading
import time

from nacreous.study.store import Answer, Response, Store, StoreError

TRIALS = 60


def answer_all(store: Store, session: str, acknowledged: int) -> None:
    for trial in range(TRIALS):
        time.sleep(0.01)  # or all would be over before the kill
        shown = {"left": f"a{trial}", "right": "b"}
        answer = Answer(trial, "deeper", shown, Response(("left", "right")[trial % 2]))
        for _ in range(600):
            try:
                store.answer(session, answer)
                break
            except StoreError:
                time.sleep(0.05)
        else:
            raise AssertionError("no answer was taken for 30 s")
        os.write(acknowledged, f"{session} {trial}\n".encode())


def main() -> None:
    place, path, study = sys.argv[1:]
    acknowledged = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    with Store.open(place) as store:
        threads = [
            threading.Thread(target=answer_all, args=(store, session.id, acknowledged))
            for session in store.sessions(study)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()


if __name__ == "__main__":
    main()
