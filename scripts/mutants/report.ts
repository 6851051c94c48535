import type { Mutant } from './mutations.ts'
import { groups, type Group, type Room } from './rooms.ts'

export type Outcome = 'killed' | 'timeout' | 'survived' | 'unasked'

export interface Tried {
  readonly mutant: Mutant
  readonly outcome: Outcome
}

export interface RoomReport {
  readonly room: Pick<Room, 'name' | 'group'>
  /** Mutants that could be drawn. */
  readonly among: number
  /** Mutants that were drawn. */
  readonly drawn: number
  readonly equivalent: number
  /** Those of the drawn ones that were tried. */
  readonly tried: readonly Tried[]
}

const isFound = ({ outcome }: Tried) => outcome === 'killed' || outcome === 'timeout'
const found = (tried: readonly Tried[]): number => tried.filter(isFound).length
const isWhole = ({ drawn, tried }: RoomReport) => tried.length === drawn

/** The share of a group's mutants that were killed; null before the first is tried. */
export function shareOf(reports: readonly RoomReport[], group: Group): number | null {
  const tried = reports.filter(({ room }) => room.group === group).flatMap((one) => one.tried)
  return tried.length === 0 ? null : found(tried) / tried.length
}

/** Does each group of which something was tried reach its goal? */
export const reachesGoals = (reports: readonly RoomReport[]): boolean =>
  (Object.keys(groups) as Group[]).every((group) => (shareOf(reports, group) ?? 1) >= groups[group].goal)

const percent = (share: number) => `${Math.floor(100 * share)} %`
const row = (cells: readonly (string | number)[]) => `| ${cells.join(' | ')} |`
const table = (head: readonly string[], rows: readonly (readonly (string | number)[])[]) =>
  [head, head.map(() => '---'), ...rows].map(row)

/** Tables of groups and rooms, the survivors, and the rooms that were not run, as Markdown. */
export function reportOf(reports: readonly RoomReport[], seed: number): string {
  const run = reports.filter(({ tried }) => tried.length > 0)
  const survivors = run.flatMap(({ tried }) => tried.filter((one) => !isFound(one)))
  const left = reports.filter((one) => !isWhole(one) || one.drawn === 0)
  return [
    '# Mutants',
    '',
    `One place at a time is changed, and the unit tests of its room run: \`npm run mutants\` (seed ${seed}; one room:`,
    '`npm run mutants -- web/storage`). Equivalent ones are listed in `scripts/mutants/equivalent.json` with their reasons.',
    '',
    ...table(['rooms', 'killed', 'share', 'goal'], groupRows(run)),
    '',
    ...table(['room', 'killed', 'share', 'places', 'equivalent'], run.map(roomRow)),
    ...section('Survivors', survivors.map(lineOf)),
    ...section('Not run, or not to the end', left.map(leftOf)),
    '',
  ].join('\n')
}

const section = (title: string, lines: readonly string[]) =>
  lines.length === 0 ? [] : ['', `## ${title}`, '', ...lines]

const names: { readonly [group in Group]: string } = { saved: 'storage and classroom', other: 'all others' }

function groupRows(run: readonly RoomReport[]) {
  return (Object.keys(groups) as Group[]).flatMap((group) => {
    const tried = run.filter(({ room }) => room.group === group).flatMap((one) => one.tried)
    return tried.length === 0 ? [] : [[names[group], ...killed(tried), percent(groups[group].goal)]]
  })
}

const roomRow = ({ room, among, equivalent, tried }: RoomReport) =>
  [room.name, ...killed(tried), among, equivalent] as const

const killed = (tried: readonly Tried[]) =>
  [`${found(tried)} of ${tried.length}`, percent(found(tried) / tried.length)] as const

const lineOf = ({ mutant: { file, line, change }, outcome }: Tried) =>
  `- \`${file}:${line}\`: \`${change.replaceAll('`', "'")}\`${outcome === 'unasked' ? ' (no test imports it)' : ''}`

const leftOf = ({ room, drawn, tried }: RoomReport) =>
  drawn === 0
    ? `- ${room.name}: no code that could be changed`
    : `- ${room.name}: ${tried.length} of ${drawn}`
