import { afterAll, expect, test } from 'vitest'
import { projectText } from '../testing/projects.ts'
import { checkInWorker } from './check-in-worker.ts'
import { checkProject } from './checked.ts'

const { check, close } = checkInWorker()
afterAll(close)

test('the worker says what the parser says', async () => {
  const texts = [projectText('a'), '{}', 'no json', projectText('b')]
  expect(await Promise.all(texts.map((text) => check(text)))).toEqual(texts.map(checkProject))
})

/** A program of 5,000 blocks, 1.1 MB. */
function largeText(mark: string): string {
  const blocks = Array.from({ length: 5000 }, (_, at) => ({
    ...{ id: `b${at}`, type: 'robActions_play_tone' },
    values: Object.fromEntries(
      ['FREQUENCE', 'DURATION'].map((name) => [
        name,
        { id: `${name}${at}`, type: 'math_number', fields: { NUM: '100' } },
      ]),
    ),
  }))
  const project = JSON.parse(projectText(mark)) as object
  const main = { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
  return JSON.stringify({ ...project, programs: { main } })
}

test('a small project does not wait for large ones, and a large one of another class waits for one of them at most', async () => {
  const own = checkInWorker()
  const order: string[] = []
  const checked = async (name: string, text: string, pupil: string, classId: string) => {
    expect(await own.check(text, { pupil, class: classId })).toHaveProperty('hash')
    order.push(name)
  }
  await checked('first', projectText('first'), 'owl', '5b')
  await Promise.all([
    ...[1, 2, 3, 4].map((at) => checked(`fox ${at}`, largeText(`${at}`), 'fox', '5b')),
    checked('hare', largeText('h'), 'hare', '6a'),
    checked('small', projectText('s'), 'owl', '5b'),
  ])
  expect(order.filter((name) => name !== 'small')).toEqual([
    ...['first', 'fox 1', 'hare', 'fox 2', 'fox 3', 'fox 4'],
  ])
  expect(order.indexOf('small')).toBeLessThan(order.indexOf('fox 4'))
  await own.close()
})

test('what takes too long is refused, and the next is checked all the same', async () => {
  const hasty = checkInWorker(1)
  const large = projectText('x'.repeat(4_000_000))
  expect(await hasty.check(large)).toEqual({ refused: 'tooLong' })
  await hasty.close()
  expect(await check(projectText('c'))).toMatchObject({ name: 'Garden c' })
})
