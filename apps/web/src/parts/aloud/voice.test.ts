import { afterEach, expect, test, vi } from 'vitest'
import { speak, voiceFor } from './voice.ts'

afterEach(() => vi.unstubAllGlobals())

const voice = (lang: string, localService = true) => ({ lang, localService })
const device = (voices: readonly ReturnType<typeof voice>[]) => {
  const speech = Object.assign(new EventTarget(), {
    getVoices: () => voices,
    cancel: vi.fn(),
    speak: vi.fn(),
  })
  vi.stubGlobal('speechSynthesis', speech)
  return speech
}

test('a voice is found by its language, wherever people speak it', async () => {
  device([voice('fr-FR'), voice('de_AT'), voice('en-GB')])
  expect(await voiceFor('de')).toMatchObject({ lang: 'de_AT' })
})

test('a voice that sends what is read elsewhere is none', async () => {
  device([voice('de-DE', false)])
  expect(await voiceFor('de')).toBeUndefined()
})

test('a device that cannot speak reads nothing, and says so', async () => {
  vi.stubGlobal('speechSynthesis', undefined)
  expect([await voiceFor('de'), await speak('Hallo.', 'de')]).toEqual([undefined, false])
})

test('what was being read stops, even where there is no voice for what comes', async () => {
  const speech = device([voice('en-GB')])
  expect(await speak('Hallo.', 'de')).toBe(false)
  expect(speech.cancel).toHaveBeenCalledOnce()
  expect(speech.speak).not.toHaveBeenCalled()
})
