const bits = new DataView(new ArrayBuffer(8))

/** How far `x` lies from the true value hi + lo, in units of hi's last place. */
export function ulps(x: number, hi: number, lo: number): number {
  bits.setFloat64(0, Math.abs(hi))
  const here = bits.getBigInt64(0)
  bits.setBigInt64(0, here === 0n ? 1n : here - 1n)
  return Math.abs(x - hi - lo) / Math.abs(Math.abs(hi) - bits.getFloat64(0))
}
