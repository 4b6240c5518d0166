/** Days and times of TOML. */

import { Moment } from "../value";

const TIME = "([01][0-9]|2[0-3]):([0-5][0-9]):([0-5][0-9])(?:\\.([0-9]{1,6})[0-9]*)?";
const DATE = "([0-9]{4})-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])";
const ZONE = "([Zz])|([+-])([01][0-9]|2[0-3]):([0-5][0-9])";
const LOCAL_TIME = new RegExp(TIME, "y");
const DAY_AND_TIME = new RegExp(`${DATE}(?:[Tt ]${TIME}(?:${ZONE})?)?`, "y");

/** The day or time that begins here, and where it ends; "invalid" for a day that no month has. */
export function momentAt(
  text: string,
  position: number,
): { moment: Moment; end: number } | "invalid" | undefined {
  DAY_AND_TIME.lastIndex = position;
  const day = DAY_AND_TIME.exec(text);
  if (day) {
    const moment = dayAndTime(day);
    return moment ? { moment, end: DAY_AND_TIME.lastIndex } : "invalid";
  }
  LOCAL_TIME.lastIndex = position;
  const time = LOCAL_TIME.exec(text);
  if (!time) return undefined;
  const [, hour, minute, second, part] = time;
  const moment = new Moment(`${hour}:${minute}:${second}${microseconds(part)}`, false);
  return { moment, end: LOCAL_TIME.lastIndex };
}

function dayAndTime(found: RegExpExecArray): Moment | undefined {
  const [, year = "", month = "", day = "", hour, minute, second, part] = found;
  const [zulu, sign, zoneHour, zoneMinute] = found.slice(8);
  if (!isDay(Number(year), Number(month), Number(day))) return undefined;
  const date = `${year}-${month}-${day}`;
  if (hour === undefined) return new Moment(date, true);
  let zone = zulu ? "+00:00" : "";
  if (sign)
    zone = `${zoneHour === "00" && zoneMinute === "00" ? "+" : sign}${zoneHour}:${zoneMinute}`;
  return new Moment(`${date} ${hour}:${minute}:${second}${microseconds(part)}${zone}`, false);
}

function microseconds(part: string | undefined): string {
  const padded = (part ?? "").padEnd(6, "0");
  return padded === "000000" ? "" : `.${padded}`;
}

/** Whether the calendar has the day. */
export function isDay(year: number, month: number, day: number): boolean {
  if (year < 1 || month < 1 || month > 12 || day < 1) return false;
  const isLeap = (year % 4 === 0 && year % 100 !== 0) || year % 400 === 0;
  const days = [31, isLeap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
  return day <= (days[month - 1] ?? 0);
}
