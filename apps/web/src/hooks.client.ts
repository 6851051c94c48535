import { fetchWords } from '#words/message.ts'

// Every page says some of them. Asked for before it is known which page it is; who needs them hears of it if they do not come.
fetchWords('app').catch(() => undefined)
