import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { fromBase64, groupBy, parseUrl, toBase64 } from './index.ts'

describe('like the functions of Node', () => {
  test('groupBy groups as Map.groupBy does, by keys of any kind', () => {
    const key = fc.oneof(
      fc.integer({ min: -2, max: 2 }),
      fc.constantFrom(-0, NaN, undefined, null, 'a', true),
    )
    fc.assert(
      fc.property(fc.array(key), (keys) => {
        const items = keys.map((one, index) => ({ key: one, index }))
        const calls: number[] = []
        const found = groupBy(items, ({ key: one }, index) => (calls.push(index), one))
        const native = Map.groupBy(items, ({ key: one }) => one)
        expect([...found].map(([one]) => one)).toEqual([...native].map(([one]) => one))
        expect([...found.values()]).toEqual([...native.values()])
        expect(calls).toEqual(items.map(({ index }) => index))
      }),
    )
  })

  test('bytes become base64 and come back, also more than fit into one call', () => {
    const longest = fc.uint8Array({ maxLength: 200 })
    fc.assert(
      fc.property(longest, (bytes) => {
        const text = toBase64(bytes)
        expect(text).toBe(Buffer.from(bytes).toString('base64'))
        expect(fromBase64(text)).toEqual(bytes)
      }),
    )
    const many = Uint8Array.from({ length: 300_001 }, (_, at) => at % 251)
    expect(toBase64(many)).toBe(Buffer.from(many).toString('base64'))
    expect(fromBase64(toBase64(many))).toEqual(many)
  })

  test.each(['=', 'a', 'ab$d', 'ü'])('%j is no base64', (text) => {
    expect(() => fromBase64(text)).toThrow()
  })

  test('parseUrl reads what URL.parse reads, and returns null for the rest', () => {
    const texts = fc.oneof(
      fc.webUrl({ size: 'xsmall' }),
      fc.string(),
      fc.constantFrom('http://', 'http://a:99999', '//a', 'https://bö.de/ä'),
    )
    fc.assert(
      fc.property(texts, (text) => {
        expect(parseUrl(text)?.href ?? null).toBe(URL.parse(text)?.href ?? null)
      }),
    )
  })
})
