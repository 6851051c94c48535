import type { Mutant } from './mutations.ts'
import type { Room } from './rooms.ts'

type Outcome = 'killed' | 'timeout' | 'survived' | 'unasked'

export interface Tried {
  readonly mutant: Mutant
  readonly outcome: Outcome
}

export interface RoomReport {
  readonly name: string
  readonly room: Room
  readonly among: number
  readonly equivalent: number
  readonly tried: readonly Tried[]
}

const isFound = ({ outcome }: Tried) => outcome === 'killed' || outcome === 'timeout'

export const shareOf = ({ tried }: RoomReport): number =>
  tried.length === 0 ? 0 : tried.filter(isFound).length / tried.length

/** The table and the survivors, as Markdown. */
export function reportOf(reports: readonly RoomReport[], seed: number): string {
  const percent = (share: number) => `${Math.floor(100 * share)} %`
  const rows = reports.map((report) => {
    const { name, room, among, equivalent, tried } = report
    const killed = tried.filter(isFound).length
    const cells = [name, `${killed} of ${tried.length}`, percent(shareOf(report)), percent(room.goal)]
    return `| ${[...cells, among, equivalent].join(' | ')} |`
  })
  const survivors = reports.flatMap(({ tried }) => tried.filter((one) => !isFound(one)))
  return [
    '# Mutants',
    '',
    `One line at a time is changed, and the unit tests are asked: \`npm run mutants\` (seed ${seed}; one room:`,
    '`npm run mutants -- storage`). Equivalent ones are listed in `scripts/mutants/equivalent.json`, each with its reason.',
    '',
    '| room | killed | share | goal | of so many | equivalent |',
    '| ---- | ------ | ----- | ---- | ---------- | ---------- |',
    ...rows,
    ...(survivors.length === 0 ? [] : ['', '## Survivors', '', ...survivors.map(lineOf)]),
    '',
  ].join('\n')
}

const lineOf = ({ mutant: { file, line, change }, outcome }: Tried) =>
  `- \`${file}:${line}\`: \`${change.replaceAll('`', "'")}\`${outcome === 'unasked' ? ' (no test imports it)' : ''}`
