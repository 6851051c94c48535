import type { Slot } from './pi/slots.ts'

export interface Partition {
  readonly name: 'boot' | Slot | 'data'
  readonly mib: number
  /** Its type in the table: 0x0c FAT32, 0x83 Linux. */
  readonly type: number
}

/** Of the card, in this order; the data get the rest of the card at the first start. */
export const partitions: readonly Partition[] = [
  { name: 'boot', mib: 512, type: 0x0c },
  { name: 'a', mib: 1536, type: 0x83 },
  { name: 'b', mib: 1536, type: 0x83 },
  { name: 'data', mib: 128, type: 0x83 },
]

/** Id of the partition table: partitions are found by it (`PARTUUID=b07a9a27-02`). */
export const diskId = 'b07a9a27'

export const sector = 512
export const mib = 1024 * 1024
/** Cards erase in blocks of at most so many MiB. */
const alignment = 4

export interface Placed extends Partition {
  /** First sector. */
  readonly start: number
  readonly sectors: number
}

/** One behind the other, each on a boundary of 4 MiB; the first one leaves room for the table. */
export function place(list: readonly Partition[]): readonly Placed[] {
  const perMib = mib / sector
  let next = alignment
  return list.map((partition) => {
    const start = next
    next = Math.ceil((start + partition.mib) / alignment) * alignment
    return { ...partition, start: start * perMib, sectors: partition.mib * perMib }
  })
}

/** How many bytes all partitions need. */
export const sizeOf = (placed: readonly Placed[]): number =>
  Math.max(...placed.map(({ start, sectors }) => start + sectors)) * sector

/**
 * The first sector: a master boot record, which the firmware of every Pi reads (a GPT not that of a Pi 3). Cylinders and
 * heads mean nothing on a card: FE FF FF sends everybody to the sectors.
 * @param id 8 hex digits @throws where there are more than four partitions, or one ends behind 2 TiB
 */
export function bootRecord(placed: readonly Placed[], id: string): Buffer {
  if (placed.length > 4) throw new RangeError('A boot record has four partitions.')
  const record = Buffer.alloc(sector)
  record.writeUInt32LE(Number.parseInt(id, 16), 440)
  placed.forEach(({ start, sectors, type }, at) => {
    const entry = 446 + at * 16
    record.write('00feffff', entry, 'hex')
    record.writeUInt8(type, entry + 4)
    record.write('feffff', entry + 5, 'hex')
    record.writeUInt32LE(start, entry + 8)
    record.writeUInt32LE(sectors, entry + 12)
  })
  record.writeUInt16LE(0xaa55, 510)
  return record
}
