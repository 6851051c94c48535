import { afterAll, expect, test } from 'vitest'
import { projectText } from '../testing/projects.ts'
import { checkInWorker } from './check-in-worker.ts'
import { checkProject } from './checked.ts'

const { check, close } = checkInWorker()
afterAll(close)

test('the worker says what the parser says', async () => {
  const texts = [projectText('a'), '{}', 'no json', projectText('b')]
  expect(await Promise.all(texts.map(check))).toEqual(texts.map(checkProject))
})

test('what takes too long is refused, and the next is checked all the same', async () => {
  const hasty = checkInWorker(1)
  const large = projectText('x'.repeat(4_000_000))
  expect(await hasty.check(large)).toEqual({ refused: 'tooLong' })
  await hasty.close()
  expect(await check(projectText('c'))).toMatchObject({ name: 'Garden c' })
})
