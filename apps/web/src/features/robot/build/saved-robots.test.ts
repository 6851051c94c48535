import { cardConfig, defaultConfig } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { mostKept } from './kept.ts'
import { SavedRobots } from './saved-robots.svelte.ts'

const texts = new Map<string, string>()
beforeEach(() => {
  texts.clear()
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => texts.get(key) ?? null,
    setItem: (key: string, text: string) => void texts.set(key, text),
  })
})
afterEach(() => void vi.unstubAllGlobals())

it('a robot that is saved is there the next time', () => {
  expect(new SavedRobots().save('Bo', cardConfig)).toBe(true)
  expect(new SavedRobots().robots).toEqual({ Bo: cardConfig })
})

it('the robot that was removed last can be restored, until another one is saved', () => {
  const saved = new SavedRobots()
  saved.save('Bo', cardConfig)
  saved.remove('Bo')
  expect([saved.robots, saved.removed?.name]).toEqual([{}, 'Bo'])
  saved.restore()
  expect([saved.robots, saved.removed]).toEqual([{ Bo: cardConfig }, null])
  saved.remove('Bo')
  saved.save('Wall-E', defaultConfig)
  saved.restore()
  expect(Object.keys(saved.robots)).toEqual(['Wall-E'])
})

it('one robot too many is not saved and says why, until one is saved again', () => {
  const saved = new SavedRobots()
  for (let k = 0; k < mostKept; k++) saved.save(`robot ${k}`, cardConfig)
  expect([saved.save('one more', cardConfig), saved.error]).toEqual([false, 'full'])
  expect([saved.save('robot 3', defaultConfig), saved.error]).toEqual([true, null])
})

it('a robot that the device refuses is not saved and says so', () => {
  vi.stubGlobal('localStorage', undefined)
  const saved = new SavedRobots()
  expect([saved.save('Bo', cardConfig), saved.error, saved.robots]).toEqual([false, 'refused', {}])
})
