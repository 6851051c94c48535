// Rooms: figures, training, q-learning, sorting
import { Learner } from '../child-learning.ts'
import { ProofHands } from '../child-proof.ts'
import { SortingHands } from '../child-sorting.ts'
import { Teaching } from '../child-training.ts'
import { expect, test } from '../house.ts'

const rows = `eyeLeft,eyeRight,wheelLeft,wheelRight
40,40,45,45
39,59,25,60
100,53,65,25
`

test('the error of a network says how it came about, and its notebook makes it again', async ({ child }) => {
  const [teaching, proof] = [new Teaching(child), new ProofHands(child)]
  await child.opensLab('friendship')
  await teaching.shows()
  await teaching.opensFile('rows.csv', rows)
  await teaching.seesExamples(3)
  await teaching.letsPractise()
  await expect(child.button('proof.sign')).toHaveAttribute('aria-disabled', 'true')
  await teaching.practises()
  await proof.asks()
  const [, percent] = /= ([\d.]+) percent$/.exec(await proof.sum())!
  const { name, number } = await proof.saves()
  expect(name).toMatch(/\.ipynb$/)
  expect(number).toBeCloseTo(Number(percent), 2)
  await proof.closes()
})

test('a number of the table says how it came about, and its notebook makes it again', async ({ child }) => {
  const [learner, proof] = [new Learner(child), new ProofHands(child)]
  await learner.opens('railway')
  await child.presses('q.step')
  await proof.asks()
  const [, after] = / = ([\d.−-]+)$/.exec(await proof.sum())!
  expect((await proof.saves()).number).toBeCloseTo(Number(after), 3)
})

test('the sum of distances says what each group has to it, and its notebook makes it again', async ({
  child,
}) => {
  const [sorting, proof] = [new SortingHands(child), new ProofHands(child)]
  await sorting.opens()
  await sorting.sorts()
  await sorting.seesDone()
  await proof.asks()
  const [, all] = /^[\d.]+ \+ [\d.]+ \+ [\d.]+ = ([\d.]+)$/.exec(await proof.sum())!
  expect((await proof.saves()).number).toBeCloseTo(Number(all), 2)
})
