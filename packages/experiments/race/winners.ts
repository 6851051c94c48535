import { layOutWorld, type Task } from '@botgarten/learning/q-learning'
import { criteria, type Bill, type Criterion } from './types.ts'

/** What a bill is judged by: less is better for all of them. */
const scores: { readonly [criterion in Criterion]: (bill: Bill) => number } = {
  way: ({ first }) => first ?? Infinity,
  stars: ({ stars }) => -stars,
  falls: ({ falls }) => falls,
}

/** Which bills are best; several where they are alike, none where nobody came so far. */
export function winnersOf(bills: readonly Bill[], criterion: Criterion): readonly number[] {
  const all = bills.map(scores[criterion])
  const best = Math.min(...all)
  return all.flatMap((score, lane) => (score === best && best < Infinity ? [lane] : []))
}

/** Lanes from best to worst; equal ones stay as they stand. */
export const orderOf = (bills: readonly Bill[], criterion: Criterion): readonly number[] =>
  bills
    .map((bill, lane) => ({ lane, score: scores[criterion](bill) }))
    .toSorted((a, b) => (a.score === b.score ? 0 : a.score - b.score))
    .map(({ lane }) => lane)

/** What can count on a map: falls where one can fall, a good way where moves lead where they are meant to. */
export function criteriaOn(task: Task): readonly Criterion[] {
  const { isFall, isSlippery } = layOutWorld(task)
  const counts = { way: !isSlippery, stars: true, falls: isFall.includes(1) }
  return criteria.filter((one) => counts[one])
}
