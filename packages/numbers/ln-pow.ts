import { add, divide, multiply, productOf, single, sumOf, type Doubled } from './doubled.ts'

const ln2: Doubled = { high: 0.6931471805599453, low: 2.3190468138462996e-17 }
const word = new DataView(new ArrayBuffer(8))

/** 2 to a whole power −1074..1023, exactly. */
function powerOfTwo(exponent: number): number {
  if (exponent < -1022) return powerOfTwo(exponent + 100) * 7.888609052210118e-31
  word.setBigUint64(0, BigInt(exponent + 1023) << 52n)
  return word.getFloat64(0)
}

/** x = part · 2^exponent, part in √½..√2; for normal x above 0. */
function partsOf(x: number): { part: number; exponent: number } {
  word.setFloat64(0, x)
  const exponent = ((word.getUint32(0) >>> 20) & 2047) - 1023
  const part = x / powerOfTwo(exponent)
  return part > Math.SQRT2 ? { part: part / 2, exponent: exponent + 1 } : { part, exponent }
}

/** ln x in two doubles: ln part = 2 artanh((part − 1)/(part + 1)), by its series (Abramowitz & Stegun 4.1.27). */
function lnOf(x: number): Doubled {
  if (x < 1e-300) return add(lnOf(x * 1.2676506002282294e30), multiply(single(-100), ln2))
  const { part, exponent } = partsOf(x)
  const s = divide(sumOf(part, -1), sumOf(part, 1))
  const square = multiply(s, s)
  let series: Doubled = single(0)
  for (let n = 21; n >= 0; n--) series = add(multiply(series, square), divide(single(1), single(2 * n + 1)))
  return add(multiply(single(exponent), ln2), multiply(multiply(single(2), s), series))
}

/** e^x = 2^exponent · (1 + more): Taylor's series of what is left beside a power of two. */
function partsOfExp(x: Doubled): { exponent: number; more: Doubled } {
  const exponent = Math.round(x.high / ln2.high)
  const rest = add(x, multiply(single(-exponent), ln2))
  let series = 0
  for (let n = 17; n >= 2; n--) series = (series * rest.high + 1) / n
  const tail = rest.low + rest.low * rest.high + series * rest.high * rest.high
  return { exponent, more: sumOf(rest.high, tail) }
}

/** e to a sum of two doubles. */
function expOf(x: Doubled): number {
  if (x.high > 709.79) return Infinity
  if (x.high < -745.2) return 0
  const { exponent, more } = partsOfExp(x)
  return scaled(1 + (more.high + more.low), exponent)
}

const scaled = (x: number, exponent: number) => {
  const half = Math.trunc(exponent / 2)
  return x * powerOfTwo(half) * powerOfTwo(exponent - half)
}

/** The natural logarithm, within 1 ulp. −Infinity for 0, NaN below. */
export function ln(x: number): number {
  if (!(x > 0)) return x === 0 ? -Infinity : NaN
  return x === Infinity ? x : lnOf(x).high
}

/** The logarithm to base 10, within 1 ulp; whole for powers of ten. */
export function log10(x: number): number {
  if (!(x > 0) || x === Infinity) return ln(x)
  return divide(lnOf(x), lnOf(10)).high
}

/** x to the power y, within 1 ulp where the result is a normal number; what ECMA-262 and Java say in the corners. */
export function pow(x: number, y: number): number {
  if (y === 0) return 1
  if (Number.isNaN(x) || Number.isNaN(y)) return NaN
  if (!Number.isFinite(y)) return atNoEnd(Math.abs(x), y)
  if (x === 0 || !Number.isFinite(x)) return ofNoEnd(x, y)
  if (x < 0 && !Number.isInteger(y)) return NaN
  if (y === 0.5) return Math.sqrt(x)
  const size = sizeOf(Math.abs(x), y)
  return x < 0 && y % 2 !== 0 ? -size : size
}

function atNoEnd(size: number, y: number): number {
  if (size === 1) return NaN
  return size > 1 === y > 0 ? Infinity : 0
}

function ofNoEnd(x: number, y: number): number {
  const size = (x === 0) === y > 0 ? 0 : Infinity
  return (x < 0 || Object.is(x, -0)) && Math.abs(y % 2) === 1 ? -size : size
}

function sizeOf(x: number, y: number): number {
  if (Number.isInteger(y) && y > 0 && y <= 64) return wholePower(x, y)
  const { high, low } = lnOf(x)
  const product = productOf(high, y)
  if (Math.abs(product.high) > 800) return product.high > 0 ? Infinity : 0
  return expOf(sumOf(product.high, product.low + low * y))
}

/** Powers of whole numbers come out whole. */
function wholePower(x: number, y: number): number {
  let result: Doubled = single(1)
  let base: Doubled = single(x)
  for (let left = y; left > 0; left = Math.floor(left / 2)) {
    if (left % 2 === 1) result = multiply(result, base)
    base = multiply(base, base)
  }
  return Number.isFinite(result.high) ? result.high : plainPower(x, y)
}

/** Near the greatest number the split of a product would overflow. */
function plainPower(x: number, y: number): number {
  let result = 1
  for (let k = 0; k < y; k++) result *= x
  return result
}
