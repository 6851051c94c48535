import type { Brain } from '@botgarten/learning/neural-network/brain'
import { place, type Row } from '@botgarten/learning/neural-network/examples'
import type { Moment } from './moment.ts'

// What checks ask of the table of the first robot's network.

const noRows: readonly Row[] = []

export const rowsIn = ({ taught }: Moment): readonly Row[] => taught?.examples?.rows ?? noRows

export const isOn = (row: Row) => row[place.on] === 1

/** Indices of the drives of which something holds. */
export function drivesWhere(
  { taught }: Moment,
  holds: (drive: NonNullable<Brain['examples']>['drives'][number]) => boolean,
): ReadonlySet<number> {
  const drives = taught?.examples?.drives ?? []
  return new Set([...drives.keys()].filter((index) => holds(drives[index]!)))
}

export const isIn = (drives: ReadonlySet<number>, row: Row) => drives.has(row[place.drive]!)
