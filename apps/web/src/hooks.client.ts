import { fetchWords } from '#words/message.ts'

// Asked for before it is known which page it is. Every page says some of them; who needs them hears of it if they do not come.
fetchWords('app').catch(() => undefined)

// Written in other letters first, a screen would be laid out and painted twice.
const style = getComputedStyle(document.documentElement)
for (const name of ['--title', '--read'])
  document.fonts.load(`700 16px ${style.getPropertyValue(name)}`).catch(() => undefined)
