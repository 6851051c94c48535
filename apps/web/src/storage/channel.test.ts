import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { until } from './testing/device.ts'

// Two pages of one browser: each has a channel module of its own.
async function page() {
  vi.resetModules()
  return import('./channel.ts')
}

const stops: (() => void)[] = []
beforeEach(() => void (stops.length = 0))
afterEach(() => {
  for (const stop of stops) stop()
  vi.unstubAllGlobals()
})
const settle = async () => {
  for (let turns = 0; turns < 30; turns += 1) await new Promise((done) => setImmediate(done))
}
async function watching() {
  const seen: string[] = []
  const { watchTabs } = await page()
  const stop = watchTabs({
    open: (id) => seen.push(`open ${id}`),
    closed: (id) => seen.push(`closed ${id}`),
    changed: () => seen.push('changed'),
  })
  stops.push(stop)
  return { seen, stop }
}

test('a page hears of projects that are open already, and of all that open, close and change later', async () => {
  const lab = await page()
  stops.push(lab.whenChangedElsewhere('early', () => {}))
  const { seen, stop } = await watching()
  await until(() => seen.length === 1)
  expect(seen).toEqual(['open early'])
  const close = lab.whenChangedElsewhere('late', () => {})
  await until(() => seen.length === 2)
  lab.announce({ kind: 'saved', id: 'late', revision: 1 })
  lab.announce({ kind: 'gone', id: 'late' })
  await until(() => seen.length === 4)
  close()
  await until(() => seen.length === 5)
  expect(seen.slice(1)).toEqual(['open late', 'changed', 'changed', 'closed late'])
  stop()
  lab.announce({ kind: 'gone', id: 'early' })
  await settle()
  expect(seen).toHaveLength(5)
})

test('a question who is there is no change', async () => {
  const { seen } = await watching()
  await watching()
  await settle()
  expect(seen).toEqual([])
})

test('a lab hears of its own project alone, until it closes', async () => {
  const [lab, other] = [await page(), await page()]
  const heard: unknown[] = []
  const stop = lab.whenChangedElsewhere('mine', (news) => heard.push(news))
  stops.push(other.whenChangedElsewhere('mine', () => {}))
  other.announce({ kind: 'saved', id: 'other', revision: 1 })
  other.announce({ kind: 'gone', id: 'other' })
  other.announce({ kind: 'saved', id: 'mine', revision: 2, name: 'n' })
  other.announce({ kind: 'gone', id: 'mine' })
  await until(() => heard.length === 2)
  expect(heard).toEqual([
    { kind: 'saved', id: 'mine', revision: 2, name: 'n' },
    { kind: 'gone', id: 'mine' },
  ])
  stop()
  other.announce({ kind: 'gone', id: 'mine' })
  await settle()
  expect(heard).toHaveLength(2)
})

test('a browser without such a channel works, and hears nothing', async () => {
  vi.stubGlobal('BroadcastChannel', undefined)
  const { announce, watchTabs, whenChangedElsewhere } = await page()
  const heard: unknown[] = []
  const stop = whenChangedElsewhere('a', (news) => heard.push(news))
  const leave = watchTabs({ open: () => {}, closed: () => {}, changed: () => heard.push('changed') })
  announce({ kind: 'gone', id: 'a' })
  await settle()
  stop()
  leave()
  expect(heard).toEqual([])
})

test('a page hears of everything that is saved or deleted, its own too, and of nothing else, until it stops', async () => {
  const [lab, other] = [await page(), await page()]
  const heard: string[] = []
  const stop = lab.whenAnythingChanges(() => heard.push('changed'))
  lab.announce({ kind: 'saved', id: 'own', revision: 1 })
  await until(() => heard.length === 1)
  other.announce({ kind: 'gone', id: 'theirs' })
  await until(() => heard.length === 2)
  stops.push(other.whenChangedElsewhere('open', () => {}))
  await settle()
  expect(heard).toHaveLength(2)
  stop()
  lab.announce({ kind: 'saved', id: 'own', revision: 2 })
  await settle()
  expect(heard).toHaveLength(2)
})
