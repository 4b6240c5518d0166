/** Numbers written as Python writes them. */

/** The shortest digits that mean this number, and where their point is: 12.5 is "125" and 2. */
function decimal(size: number): { digits: string; point: number } {
  const [mantissa = "", exponent = ""] = size.toExponential().split("e");
  return { digits: mantissa.replace(".", ""), point: Number(exponent) + 1 };
}

function fixed(digits: string, point: number): string {
  if (point <= 0) return `0.${"0".repeat(-point)}${digits}`;
  if (point >= digits.length) return `${digits.padEnd(point, "0")}.0`;
  return `${digits.slice(0, point)}.${digits.slice(point)}`;
}

function scientific(digits: string, point: number, width: number): string {
  const mantissa = digits.length > 1 ? `${digits[0]}.${digits.slice(1)}` : digits;
  const exponent = String(Math.abs(point - 1)).padStart(width, "0");
  return `${mantissa}e${point < 1 ? "-" : "+"}${exponent}`;
}

/** A float as Python's `repr` has it: 20.0, 1e-05, inf. */
export function repr(number: number): string {
  if (Number.isNaN(number)) return "nan";
  const sign = number < 0 || Object.is(number, -0) ? "-" : "";
  if (!Number.isFinite(number)) return `${sign}inf`;
  const { digits, point } = decimal(Math.abs(number));
  return sign + (point > -4 && point <= 16 ? fixed(digits, point) : scientific(digits, point, 2));
}

/** A finite float as pydantic's JSON has it, whose exponents begin elsewhere. */
export function json(number: number): string {
  const sign = number < 0 || Object.is(number, -0) ? "-" : "";
  const { digits, point } = decimal(Math.abs(number));
  return sign + (point > -5 && point <= 16 ? fixed(digits, point) : scientific(digits, point, 0));
}

/** A float as Python's format `g` has it: so many significant digits, no zeros behind. */
export function general(number: number, precision = 6): string {
  if (!Number.isFinite(number)) return repr(number);
  if (number === 0) return Object.is(number, -0) ? "-0" : "0";
  const sign = number < 0 ? "-" : "";
  const { digits, point } = rounded(Math.abs(number), precision);
  const short = digits.replace(/0+$/, "");
  if (point <= -4 || point > precision) return sign + scientific(short, point, 2);
  return sign + fixed(short, point).replace(/\.0$/, "");
}

/** To even where the number lies in the middle of two: JavaScript alone goes up. */
function rounded(size: number, precision: number): { digits: string; point: number } {
  const [mantissa = "", exponent = ""] = size.toExponential(60).split("e");
  const digits = mantissa.replace(".", "");
  const isTie = /^50*$/.test(digits.slice(precision));
  if (isTie && Number(digits[precision - 1]) % 2 === 0) {
    return { digits: digits.slice(0, precision), point: Number(exponent) + 1 };
  }
  const [nearest = "", power = ""] = size.toExponential(precision - 1).split("e");
  return { digits: nearest.replace(".", ""), point: Number(power) + 1 };
}
