"""People before a server: participants and experimenters, as their pages would ask."""

from dataclasses import dataclass, field
from typing import Any

import httpx

from tests.support.server_process import NAME, PASSWORD

WINDOW = {"window": {"width_px": 1920, "height_px": 1080, "device_pixel_ratio": 1}}


@dataclass
class Person:
    """A participant with a token, by any client of httpx."""

    client: httpx.Client
    token: str
    headers: dict[str, str] = field(init=False)

    def __post_init__(self) -> None:
        self.headers = {"Authorization": f"Bearer {self.token}"}

    @classmethod
    def new(cls, client: httpx.Client) -> "Person":
        """Somebody who has a token and has not entered."""
        return cls(client, client.get("/api/study").json()["token"])

    @classmethod
    def consented(cls, client: httpx.Client) -> "Person":
        """Somebody who may answer."""
        person = cls.new(client)
        person.enter()
        person.post("consent")
        return person

    def enter(self, **other: Any) -> httpx.Response:
        return self.post("enter", {"language": "en", "groups": {"trade": "yes"}, **other})

    def post(self, what: str, body: Any = None, **options: Any) -> httpx.Response:
        return self.client.post(f"/api/{what}", json=body, headers=self.headers, **options)

    def get(self, what: str) -> httpx.Response:
        return self.client.get(f"/api/{what}", headers=self.headers)

    def sitting(self) -> dict[str, Any]:
        told: dict[str, Any] = self.get("sitting").json()
        return told

    def answer(self, trial: object, chosen: str = "left", /, **other: Any) -> httpx.Response:
        body = {"chosen": chosen, "response_ms": 1840.5, **other}
        return self.client.put(f"/api/answers/{trial}", json=body, headers=self.headers)


@dataclass
class Experimenter:
    """Somebody who is logged in; the client keeps the cookie."""

    client: httpx.Client
    csrf: str

    @classmethod
    def login(cls, client: httpx.Client) -> "Experimenter":
        told = client.post("/lab/api/login", json={"name": NAME, "password": PASSWORD})
        assert told.status_code == 200, told.text
        return cls(client, told.json()["csrf"])

    def get(self, what: str) -> httpx.Response:
        return self.client.get(f"/lab/api/{what}")

    def post(self, what: str, body: Any = None) -> httpx.Response:
        headers = {"X-CSRF-Token": self.csrf}
        return self.client.post(f"/lab/api/{what}", json=body, headers=headers)
