/** A number kept as the unevaluated sum of two doubles, about 106 bits (Dekker 1971). `high` is the sum rounded. */
export interface Doubled {
  readonly high: number
  readonly low: number
}

const splitter = 134217729 // 2^27 + 1

/** high + low = a + b exactly (Knuth, TAOCP 2, 4.2.2, theorem B). */
export function sumOf(a: number, b: number): Doubled {
  const high = a + b
  const part = high - a
  return { high, low: a - (high - part) + (b - part) }
}

/** high + low = a · b exactly, while nothing overflows (Dekker 1971). */
export function productOf(a: number, b: number): Doubled {
  const high = a * b
  const bigA = a * splitter
  const upperA = bigA - (bigA - a)
  const lowerA = a - upperA
  const bigB = b * splitter
  const upperB = bigB - (bigB - b)
  const lowerB = b - upperB
  return { high, low: upperA * upperB - high + upperA * lowerB + lowerA * upperB + lowerA * lowerB }
}

export function add(a: Doubled, b: Doubled): Doubled {
  const { high, low } = sumOf(a.high, b.high)
  return sumOf(high, low + a.low + b.low)
}

export function multiply(a: Doubled, b: Doubled): Doubled {
  const { high, low } = productOf(a.high, b.high)
  return sumOf(high, low + a.high * b.low + a.low * b.high)
}

export function divide(a: Doubled, b: Doubled): Doubled {
  const first = a.high / b.high
  const rest = add(a, negative(multiply({ high: first, low: 0 }, b)))
  return sumOf(first, (rest.high + rest.low) / b.high)
}

const negative = ({ high, low }: Doubled): Doubled => ({ high: -high, low: -low })
export const single = (high: number): Doubled => ({ high, low: 0 })
