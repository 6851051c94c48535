import fc from 'fast-check'

const bits = ['<', '>', '"', '&', '/', '=', '9e9', '-', '<g>', '</svg>', 'node-1', '<!--', '\u0000', '<use href="#node-0"/>'] // prettier-ignore

/** One of these drawings, of which some letters have changed. */
export function changedDrawing(files: readonly string[]): fc.Arbitrary<string> {
  const change = fc.record({
    at: fc.nat(9999),
    length: fc.nat(40),
    put: fc.oneof(fc.constantFrom(...bits), fc.string({ maxLength: 6 })),
  })
  return fc
    .record({ file: fc.constantFrom(...files), changes: fc.array(change, { minLength: 1, maxLength: 4 }) })
    .map(({ file, changes }) => changes.reduce(changed, file))
}

function changed(text: string, { at, length, put }: { at: number; length: number; put: string }): string {
  const from = Math.floor((at / 10_000) * text.length)
  return text.slice(0, from) + put + text.slice(from + length)
}
