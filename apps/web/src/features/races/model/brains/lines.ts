import type { LaneKind, LaneResult, Measure } from '@botgarten/experiments/brain-race'
import { isLess, type Summary } from '@botgarten/experiments/brain-race/table'

/** A line of the bill: a number a lane; null: it was not ready, or nobody has counted that. */
export interface Line {
  readonly id:
    'score' | 'bumps' | 'parts' | 'examples' | 'tries' | 'learningBumps' | 'hand' | 'computer' | 'decisions'
  readonly values: readonly (number | null)[]
  /** Indices of the best lanes; none where the line is no contest. */
  readonly best: readonly number[]
  /** What is counted, where that is not the same in all lanes; null: nothing. */
  readonly units?: readonly (Unit | null)[]
}

/** What a lane tried so often: moves of knobs, rounds of practice, decisions, runs. */
type Unit = 'knobs' | 'rounds' | 'decisions' | 'starts'

type Of = (summary: Summary) => number | null

/** The results of a race, and what each brain has cost. Of a line that is `no` contest nothing is the best. */
export function linesOf(summaries: readonly (Summary | null)[], measure: Measure): readonly Line[] {
  const line = (id: Line['id'], of: Of, wins: 'least' | 'most' | 'no' = 'least'): Line => {
    const values = summaries.map((summary) => summary && of(summary))
    return { id, values, best: wins === 'no' ? [] : bestOf(values, wins) }
  }
  const tries = summaries.map((summary) => summary && triesOf(summary))
  return [
    line('score', ({ score }) => score, isLess(measure) ? 'least' : 'most'),
    line('bumps', ({ bumps }) => bumps),
    line('parts', ({ bill }) => bill.parts),
    line('examples', ({ bill }) => bill.examples && bill.examples.on),
    {
      ...line('tries', (summary) => triesOf(summary)?.count ?? null, 'no'),
      units: tries.map((one) => one && one.unit),
    },
    line('learningBumps', ({ bill }) => bill.effort?.bumps ?? null),
    line('hand', ({ bill }) => minutes(bill.effort?.hand)),
    line('computer', computerOf),
    line('decisions', ({ decisions }) => decisions),
  ]
}

function triesOf({ kind, bill }: Summary): { readonly count: number; readonly unit: Unit } | null {
  const { practised, tried, effort } = bill
  if (practised) return { count: practised.rounds, unit: 'rounds' }
  if (tried) return { count: tried.decisions, unit: 'decisions' }
  const unit = kind === 'hand' ? 'knobs' : 'starts'
  const count = effort?.[unit]
  return count === undefined ? null : { count, unit }
}

const minutes = (seconds: number | undefined) => (seconds === undefined ? null : seconds / 60)

/** What a hand has set took no time of the computer. */
const withoutComputer: readonly LaneKind[] = ['hand', 'ifThen']
const computerOf: Of = ({ kind, bill }) =>
  withoutComputer.includes(kind) ? 0 : (bill.effort?.computer ?? null)

/** Only where several lanes have a number is one of them the best. */
function bestOf(values: readonly (number | null)[], wins: 'least' | 'most'): readonly number[] {
  const there = values.filter((value) => value !== null)
  if (there.length < 2) return []
  const best = wins === 'least' ? Math.min(...there) : Math.max(...there)
  return values.flatMap((value, lane) => (value === best ? [lane] : []))
}

/** The bill as CSV with commas and points: a row a line, then a row a start with what the course measures. */
export function billCsv(lines: readonly Line[], results: readonly LaneResult[]): string {
  const starts = Math.max(0, ...results.map(({ runs }) => runs?.length ?? 0))
  const row = (name: string, values: readonly (number | null)[]) =>
    [name, ...values.map((value) => value ?? '')].join(',')
  const rows = [
    ['line', ...results.map(({ kind }) => kind)].join(','),
    ...lines.map(({ id, values }) => row(id, values)),
    ...Array.from({ length: starts }, (_, start) =>
      row(
        `start_${start + 1}`,
        results.map(({ runs }) => runs?.[start]?.score ?? null),
      ),
    ),
  ]
  return `${rows.join('\n')}\n`
}
