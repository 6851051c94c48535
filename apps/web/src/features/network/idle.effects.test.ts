import type { NetworkInUse } from '@botgarten/programs'
import { flushSync, tick } from 'svelte'
import { SvelteMap } from 'svelte/reactivity'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { IdleNetwork } from './idle.svelte.ts'
import { rooted } from './testing/rooted.svelte.ts'

const net = (why: NetworkInUse['idle']) => ({ id: 'net', idle: why }) as NetworkInUse

/** The outline and whether there is room to draw it, as a page holds them. */
const page = new SvelteMap<'outline' | 'isDrawn', unknown>()
let focused: string[]
let idle: IdleNetwork
let stop: () => void
beforeEach(() => {
  page.set('outline', net('loose'))
  page.set('isDrawn', true)
  focused = []
  const root = { querySelector: (selector: string) => ({ focus: () => void focused.push(selector) }) }
  const live = () => ({
    ...{ outline: page.get('outline') as NetworkInUse | null, isDrawn: page.get('isDrawn') as boolean },
    ...{ isHeld: false, root: root as unknown as HTMLElement },
  })
  const asked = { onputin: () => {}, onswitchon: () => {} }
  ;({ made: idle, stop } = rooted(() => new IdleNetwork(live, () => asked)))
  flushSync()
})
afterEach(() => stop())

/** The elements that have been focused once the page has changed. */
async function after(what: 'outline' | 'isDrawn', value: unknown) {
  page.set(what, value)
  flushSync()
  await tick()
  return focused
}

test('once a network that was put in runs, the keyboard continues at its first knob, once', async () => {
  idle.fix()
  expect(await after('outline', net(null))).toEqual(['[role=slider]'])
  await after('outline', net('loose'))
  expect(await after('outline', net(null))).toEqual(['[role=slider]'])
})

test('the keyboard waits until the network is drawn, and stays where it is if none was put in', async () => {
  expect(await after('outline', net(null))).toEqual([])
  await after('outline', net('loose'))
  page.set('isDrawn', false)
  idle.fix()
  expect(await after('outline', net(null))).toEqual([])
  expect(await after('outline', null)).toEqual([])
  expect(await after('isDrawn', true)).toEqual([])
  expect(await after('outline', net(null))).toEqual(['[role=slider]'])
})

test('a network that was folded, ran and comes loose again says so again', async () => {
  idle.fold()
  expect(idle.isNoted).toBe(false)
  await after('outline', net(null))
  await after('outline', net('loose'))
  expect(idle.isNoted).toBe(true)
})
