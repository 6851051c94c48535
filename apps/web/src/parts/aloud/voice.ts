/** Browsers tell of their voices a moment after they are asked. */
const timeout = 1500

function voicesOf(speech: SpeechSynthesis): Promise<readonly SpeechSynthesisVoice[]> {
  const voices = speech.getVoices()
  if (voices.length > 0) return Promise.resolve(voices)
  return new Promise((resolve) => {
    const answer = () => resolve(speech.getVoices())
    speech.addEventListener('voiceschanged', answer, { once: true })
    setTimeout(answer, timeout)
  })
}

/** Only voices that are on the device: what a child reads is sent nowhere. */
const speaks = (language: string) => (voice: SpeechSynthesisVoice) =>
  voice.localService && voice.lang.toLowerCase().split(/[-_]/)[0] === language

/** A voice on this device for "de" or "en"; undefined where there is none. */
export async function voiceFor(language: string): Promise<SpeechSynthesisVoice | undefined> {
  const speech = globalThis.speechSynthesis as SpeechSynthesis | undefined
  return speech && (await voicesOf(speech)).find(speaks(language))
}

/**
 * Reads a text aloud; what was being read stops.
 * @param language "de", "en"
 * @returns when it has been read or hushed; false where the device has no voice for the language
 */
export async function speak(text: string, language: string): Promise<boolean> {
  hush()
  const voice = await voiceFor(language)
  if (!voice) return false
  const words = new SpeechSynthesisUtterance(text)
  words.voice = voice
  words.lang = voice.lang
  words.rate = 0.9
  return new Promise((resolve) => {
    words.onend = words.onerror = () => resolve(true)
    speechSynthesis.speak(words)
  })
}

export const hush = (): void => globalThis.speechSynthesis?.cancel()
