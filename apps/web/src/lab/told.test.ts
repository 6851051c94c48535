import { afterEach, expect, test, vi } from 'vitest'
import { screen } from './testing/session.ts'
import { told } from './told.ts'

afterEach(() => vi.unstubAllGlobals())

test('Blockly has told of everything after two frames, and a task after each', async () => {
  const draw = screen()
  const task = () => new Promise((done) => setTimeout(done, 1))
  let isOver = false
  void told().then(() => (isOver = true))
  await task()
  expect(isOver).toBe(false)
  draw()
  await task()
  expect(isOver).toBe(false)
  draw()
  expect(isOver).toBe(false)
  await task()
  await task()
  expect(isOver).toBe(true)
})
