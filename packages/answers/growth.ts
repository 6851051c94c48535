import { scoreOf } from './columns.ts'
import type { Comparison } from './release.ts'
import { among } from './tally.ts'
import { signedRank, type SignedRank } from './wilcoxon.ts'
import type { Answer, Column } from './types.ts'

/** How many of the questions about the robot the same children answered right, before and after. */
export interface Growth {
  /** Children whose answers were joined. */
  readonly n: number
  /** Questions of both forms. */
  readonly of: number
  /** Of each child, in random order. */
  readonly scores: readonly (readonly [before: number, after: number])[]
  /** Null where nobody's score is another. */
  readonly test: SignedRank | null
}

/** Scores of pairs; null where the forms ask no question about the robot in common. */
export function growthOf(
  { pairs }: Comparison,
  before: readonly Column[],
  after: readonly Column[],
  answers: readonly Answer[],
): Growth | null {
  const common = (columns: readonly Column[], others: readonly Column[]) =>
    columns.filter(({ id, kind }) => kind === 'robot' && others.some((one) => one.id === id))
  const [earlier, later] = [common(before, after), common(after, before)]
  if (earlier.length === 0) return null
  const byId = new Map(among(answers, pairs.flat()).map((answer) => [answer.id, answer]))
  const scores = pairs.map(
    ([one, other]) => [scoreOf(earlier, byId.get(one)!), scoreOf(later, byId.get(other)!)] as const,
  )
  const test = signedRank(scores.map(([was, is]) => is - was))
  return { n: pairs.length, of: earlier.length, scores, test }
}
