/** Controls of days. */

import { type Day, dayOf, dayOfYear, daysIn, onDay, written } from "../../state/dates";
import { dateOf } from "../../state/typed";
import { language, t } from "../../words/speech";
import type { Control } from "./Knob";
import { Typed } from "./Typed";

const MONTHS = Array.from({ length: 12 }, (_, i) => i + 1);

function monthName(month: number): string {
  const day = new Date(Date.UTC(2025, month - 1, 1));
  return new Intl.DateTimeFormat(language.value, { month: "short", timeZone: "UTC" }).format(day);
}

function spoken({ year, month, day }: Day): string {
  return year === null ? `${monthName(month)} ${day}` : written({ year, month, day });
}

/** A slider through the year, and the date itself. */
export function DateControl({ id, name, describedBy, value, set }: Control) {
  const day = dayOf(String(value));
  if (day === null) return <output id={id}>{String(value)}</output>;
  return (
    <div class="number">
      <input
        type="range"
        min={0}
        max={364}
        aria-label={name}
        aria-describedby={describedBy}
        aria-valuetext={spoken(day)}
        value={dayOfYear(day)}
        onInput={(event) => set(written(onDay(Number(event.currentTarget.value), day.year)))}
      />
      {day.year === null ? (
        <Recurring id={id} name={name} day={day} set={set} />
      ) : (
        <Dated id={id} value={value} describedBy={describedBy} set={set} />
      )}
    </div>
  );
}

type Set = Control["set"];

/** A date as ISO 8601 writes it: a browser's own field would follow the browser's country, not the page. */
function Dated({ id, value, describedBy, set }: Omit<Control, "name" | "declared">) {
  return (
    <Typed
      id={id}
      class="date"
      describedBy={describedBy}
      inputMode="numeric"
      placeholder={t("datePattern")}
      shown={String(value)}
      read={(text) => dateOf(text) ?? undefined}
      set={set}
      allowed={t("datePattern")}
    />
  );
}

/** A day of every year has no year, which a date input would want. */
function Recurring({ id, name, day, set }: { id: string; name: string; day: Day; set: Set }) {
  const to = (next: Day) => set(written({ ...next, day: Math.min(next.day, daysIn(next.month)) }));
  return (
    <span class="recurring">
      <select
        id={id}
        value={String(day.month)}
        onChange={(event) => to({ ...day, month: Number(event.currentTarget.value) })}
      >
        {MONTHS.map((month) => (
          <option key={month} value={String(month)}>
            {monthName(month)}
          </option>
        ))}
      </select>
      <select
        aria-label={name}
        value={String(day.day)}
        onChange={(event) => to({ ...day, day: Number(event.currentTarget.value) })}
      >
        {Array.from({ length: daysIn(day.month) }, (_, i) => (
          <option key={i} value={String(i + 1)}>
            {i + 1}
          </option>
        ))}
      </select>
    </span>
  );
}
