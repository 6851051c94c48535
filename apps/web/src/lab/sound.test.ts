import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Loudspeaker } from './sound.svelte.ts'

/** What an AudioContext was asked for. */
const heard: string[] = []
const drawer = new Map<string, string>()
let tapped = true

class Context {
  readonly currentTime = 5
  readonly destination = 'loudspeaker'
  createGain() {
    const gain = {
      value: 1,
      setTargetAtTime: (value: number, at: number, fade: number) =>
        heard.push(`volume ${value} at ${at} in ${fade}`),
    }
    return { gain, connect: (to: string) => heard.push(`to ${to}, volume ${gain.value}`) }
  }
  createOscillator() {
    return {
      type: 'sine',
      frequency: { setTargetAtTime: (value: number) => heard.push(`${value} Hz`) },
      connect: (volume: unknown) => volume,
      start(this: { type: string }) {
        heard.push(`start ${this.type}`)
      },
    }
  }
  close() {
    heard.push('close')
    return Promise.resolve()
  }
}

beforeEach(() => {
  heard.length = 0
  drawer.clear()
  tapped = true
  vi.stubGlobal('AudioContext', Context)
  vi.stubGlobal('navigator', {
    userActivation: {
      get hasBeenActive() {
        return tapped
      },
    },
  })
  vi.stubGlobal('localStorage', {
    getItem: (name: string) => drawer.get(name) ?? null,
    setItem: (name: string, text: string) => drawer.set(name, text),
  })
})
afterEach(() => vi.unstubAllGlobals())

test('is silent until a tap has allowed it (rule 12), and is woken once', () => {
  const speaker = new Loudspeaker()
  speaker.play(440)
  tapped = false
  speaker.wake()
  expect(heard).toEqual([])
  tapped = true
  speaker.wake()
  speaker.wake()
  expect(heard).toEqual(['to loudspeaker, volume 0', 'start triangle'])
})

test('plays a tone softly, at another height when it changes, and nothing twice', () => {
  const speaker = new Loudspeaker()
  speaker.wake()
  heard.length = 0
  speaker.play(440)
  speaker.play(440)
  speaker.play(880)
  speaker.play(null)
  speaker.play(0)
  expect(heard).toEqual([
    ...['440 Hz', 'volume 0.08 at 5 in 0.02'],
    ...['880 Hz', 'volume 0.08 at 5 in 0.02'],
    'volume 0 at 5 in 0.02',
  ])
})

test('stays off where a child has switched it off, and on where it has switched it on', () => {
  const speaker = new Loudspeaker()
  expect(speaker.on).toBe(true)
  speaker.wake()
  speaker.play(440)
  heard.length = 0
  speaker.switch(false)
  speaker.play(440)
  expect(heard).toEqual(['volume 0 at 5 in 0.02'])
  expect([speaker.on, new Loudspeaker().on]).toEqual([false, false])
  speaker.switch(true)
  expect([speaker.on, new Loudspeaker().on]).toEqual([true, true])
  expect(heard).toHaveLength(1)
  speaker.close()
  expect(heard.at(-1)).toBe('close')
})

test('a browser without sound is silent and works', () => {
  vi.stubGlobal('AudioContext', undefined)
  vi.stubGlobal('navigator', {})
  const speaker = new Loudspeaker()
  speaker.wake()
  speaker.play(440)
  speaker.close()
  expect(heard).toEqual([])
})
