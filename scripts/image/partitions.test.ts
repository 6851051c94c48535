import fc from 'fast-check'
import { expect, test } from 'vitest'
import { bootRecord, diskId, partitions, place, sizeOf } from './partitions.ts'

test('partitions lie one behind the other on boundaries of 4 MiB, none on the table or on another', () => {
  const sizes = fc.array(fc.integer({ min: 1, max: 100_000 }), { minLength: 1, maxLength: 4 })
  fc.assert(
    fc.property(sizes, (list) => {
      const placed = place(list.map((mib) => ({ name: 'data' as const, mib, type: 0x83 })))
      let end = 8192
      for (const { start, sectors, mib } of placed) {
        expect(start % 8192).toBe(0)
        expect(start).toBeGreaterThanOrEqual(end)
        expect(sectors).toBe(mib * 2048)
        end = start + sectors
      }
      expect(sizeOf(placed)).toBe(end * 512)
    }),
  )
})

test('the boot record is what sfdisk writes for the same partitions, cylinders aside', () => {
  // label-id 0xb07a9a27, "8192 1048576 c", "1056768 3145728 83" (util-linux 2.38)
  const record = bootRecord(place(partitions), diskId)
  expect(record.length).toBe(512)
  expect(record.toString('hex', 440, 444)).toBe('279a7ab0')
  expect(record.toString('hex', 446, 462)).toBe('00feffff0cfeffff0020000000001000')
  expect(record.toString('hex', 462, 478)).toBe('00feffff83feffff0020100000003000')
  expect(record.toString('hex', 510)).toBe('55aa')
})

test('a card of 4 GB is large enough, and the data come last, so that they can grow', () => {
  expect(sizeOf(place(partitions))).toBeLessThan(4_000_000_000)
  expect(partitions.at(-1)!.name).toBe('data')
  const [a, b] = ['a', 'b'].map((name) => partitions.find((one) => one.name === name)!.mib)
  expect(a).toBe(b)
})

test('more than four partitions do not fit', () => {
  const placed = place(Array.from({ length: 5 }, () => partitions[0]!))
  expect(() => bootRecord(placed, diskId)).toThrow(RangeError)
})
