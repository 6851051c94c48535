import type { Page } from '@playwright/test'

interface Heard {
  /** What was read, in its order, and by voices of which languages. */
  readonly said: string[]
  readonly languages: string[]
  /** So often somebody asked which voices there are. */
  asked: number
}

/** A device with voices for these languages, or without one; what is read is noted. */
export async function givesVoice(page: Page, voices: readonly string[]) {
  await page.addInitScript((languages) => {
    const heard: Heard = { said: [], languages: [], asked: 0 }
    const voices = languages.map((lang) => ({ lang, localService: true, name: lang }))
    Object.assign(window, { heard })
    Object.defineProperty(window, 'SpeechSynthesisUtterance', {
      value: class {
        text: string
        onend?: () => void
        constructor(text: string) {
          this.text = text
        }
      },
    })
    const speech = new EventTarget()
    Object.assign(speech, {
      getVoices: () => {
        heard.asked += 1
        return voices
      },
      cancel: () => undefined,
      speak: (words: { text: string; lang: string; onend?: () => void }) => {
        heard.said.push(words.text)
        heard.languages.push(words.lang)
        setTimeout(() => words.onend?.())
      },
    })
    Object.defineProperty(window, 'speechSynthesis', { value: speech })
  }, voices)
}

/** What was noted since the page was opened. */
export const heardOn = (page: Page): Promise<Heard> =>
  page.evaluate(() => (window as unknown as { heard: Heard }).heard)

export const said = async (page: Page): Promise<readonly string[]> => (await heardOn(page)).said
