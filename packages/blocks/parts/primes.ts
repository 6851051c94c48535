/** By trial of odd divisors up to the root; for whole numbers up to 2^53. */
function isPrime(x: number): boolean {
  if (!Number.isSafeInteger(x) || x < 2) return false
  if (x % 2 === 0) return x === 2
  for (let divisor = 3; divisor * divisor <= x; divisor += 2) if (x % divisor === 0) return false
  return true
}

/** What `math_number_property` asks of one number. Zero is neither positive nor negative. */
export const properties: ReadonlyMap<string, (x: number) => boolean> = new Map<
  string,
  (x: number) => boolean
>([
  ['EVEN', (x) => x % 2 === 0],
  ['ODD', (x) => Number.isInteger(x) && x % 2 !== 0],
  ['PRIME', isPrime],
  ['WHOLE', Number.isInteger],
  ['POSITIVE', (x) => x > 0],
  ['NEGATIVE', (x) => x < 0],
])
