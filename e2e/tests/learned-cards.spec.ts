// Rooms: training, content
import { Teaching } from '../child-training.ts'
import { test } from '../house.ts'

test('the child shows a card nine places, lets Bo practise, and Bo stays by the square', async ({
  child,
}) => {
  const teaching = new Teaching(child)
  await child.opensLab('show-it')
  await teaching.shows()
  const rows = [
    [100, 100, 70, 70],
    [100, 74.57, 70, 50],
    [74.57, 100, 50, 70],
    [100, 45.9, 70, 30],
    [45.14, 100, 30, 70],
    [25.02, 25.02, 20, 20],
    [100, 26.4, 70, 20],
    [26.4, 100, 20, 70],
    [5, 5, 0, 0],
  ]
  const table = ['eyeLeft,eyeRight,wheelLeft,wheelRight', ...rows.map((row) => row.join())].join('\n')
  await teaching.opensFile('rows.csv', `${table}\n`)
  await teaching.seesExamples(9)
  await teaching.letsPractise()
  await teaching.practises()
  await child.pressesStart()
  for (const check of ['near', 'neverTouches', 'stays', 'learned']) await child.seesCheck('show-it', check)
})

test('the child finds four wrong rows, sets them aside, and Bo stays by the square', async ({ child }) => {
  const teaching = new Teaching(child)
  await child.opensLab('four-wrong')
  await teaching.shows()
  for (const row of [22, 16, 11, 5]) await teaching.setsAside(row)
  await teaching.letsPractise()
  await teaching.practises()
  await child.pressesStart()
  for (const check of ['near', 'stays', 'clean']) await child.seesCheck('four-wrong', check)
})
