import { isLearned } from '@botgarten/lab/trying'
import { check, tryingIn, type Program } from '@botgarten/programs'
import { someIn } from './blocks.ts'
import { drive } from './drive.ts'
import type { Ground, LaneKind, LaneResult, NotReady, Racer, Run } from './types.ts'

/** A brain in its lane; null: nobody has made one. */
export interface Lane {
  readonly kind: LaneKind
  readonly racer: Racer | null
}

/**
 * Every brain drives from every start of the course, each alone, frozen as it is now: no net practises, no table explores. The
 * same lanes and seed give the same race, bit for bit. Pauses as `drive` does.
 */
export function* race(
  ground: Ground,
  lanes: readonly Lane[],
  seed: number,
): Generator<undefined, readonly LaneResult[]> {
  const results: LaneResult[] = []
  for (const { kind, racer } of lanes) {
    const problem = problemOf(ground, racer)
    results.push({ kind, problem, runs: problem || !racer ? null : yield* runsOf(ground, racer, seed) })
  }
  return results
}

function* runsOf(ground: Ground, racer: Racer, seed: number): Generator<undefined, Run[]> {
  const runs: Run[] = []
  for (const [at, start] of ground.course.starts.entries())
    runs.push(yield* drive(ground, racer, start, seed + at))
  return runs
}

/** What keeps a brain from racing; null: nothing does. */
function problemOf({ world }: Pick<Ground, 'world'>, racer: Racer | null): NotReady | null {
  const program = racer && Object.values(racer.programs)[0]
  if (!program?.stacks.some(hasStart)) return 'missing'
  if (check(program, world.robots[0]!.config).some(({ stops }) => stops)) return 'cannotRun'
  return isLearning(program) || isTrying(program, racer?.tables) ? 'learns' : null
}

const hasStart = ({ blocks: [top] }: Program['stacks'][number]) =>
  top?.type === 'robControls_start' && !top.disabled

/** Blocks that change a brain: who races has learned before. */
const learning: ReadonlySet<string> = new Set([
  ...['ai_nn_remember', 'ai_nn_practise', 'ai_nn_forget'],
  ...['robActions_set_weight', 'robActions_change_weight', 'robActions_set_bias', 'robActions_change_bias'],
])

/** Has it not tried for as long as its blocks say? Then it would begin with that. */
function isTrying(program: Program, tables: Racer['tables'] = {}): boolean {
  const outline = tryingIn(program)
  return outline !== null && !isLearned(tables[outline.id], outline.trial, outline.minutes)
}

const isLearning = ({ stacks }: Program): boolean =>
  stacks.some(({ blocks }) => blocks.some((block) => someIn(block, ({ type }) => learning.has(type))))

/** Runs a generator to its end at once. */
export function finish<Made>(making: Generator<undefined, Made>): Made {
  for (;;) {
    const { done, value } = making.next()
    if (done) return value
  }
}
