import type { NetworkInUse } from '@botgarten/programs'
import { beforeEach, expect, test } from 'vitest'
import { IdleNetwork } from './idle.svelte.ts'

// Effects do not run in Node: a browser test holds the message of a network that runs again.
let asked: string[]
let live: { outline: NetworkInUse | null; isHeld: boolean; isDrawn: boolean; root: undefined }
let idle: IdleNetwork
const net = (id: string, why: NetworkInUse['idle']) => ({ id, idle: why }) as NetworkInUse
beforeEach(() => {
  asked = []
  live = { outline: net('net', 'loose'), isHeld: false, isDrawn: true, root: undefined }
  const onputin = () => void asked.push('put in')
  const onswitchon = () => void asked.push('switch on')
  idle = new IdleNetwork(
    () => live,
    () => ({ onputin, onswitchon }),
  )
})

test('a network that does not run has its note open, until it is folded', () => {
  expect([idle.why, idle.isNoted, idle.isUnfolded]).toEqual(['loose', true, false])
  idle.fold()
  expect([idle.isNoted, idle.isUnfolded]).toEqual([false, false])
  idle.unfold()
  expect([idle.isNoted, idle.isUnfolded]).toEqual([true, true])
  idle.fold()
  expect(idle.isUnfolded).toBe(false)
})

test('the note of another network is open although one was folded', () => {
  idle.fold()
  live.outline = net('other', 'behind')
  expect([idle.why, idle.isNoted]).toEqual(['behind', true])
})

test('there is no note while a network is held, where it runs, and where there is none', () => {
  live.isHeld = true
  expect(idle.isNoted).toBe(false)
  live.isHeld = false
  live.outline = net('net', null)
  expect([idle.why, idle.isNoted]).toEqual([null, false])
  live.outline = null
  expect([idle.why, idle.isNoted]).toEqual([null, false])
})

test('the way back is switching on what is off, and putting in what is loose', () => {
  idle.fix()
  live.outline = net('net', 'behind')
  idle.fix()
  live.outline = net('net', 'off')
  idle.fix()
  expect(asked).toEqual(['put in', 'put in', 'switch on'])
})
