// For the tests: every language can be spoken at once.
import { files } from 'content:words'
import type { WordsFile } from './generated/files.ts'
import { language } from './language.svelte.ts'
import { fetchWords } from './message.ts'

const all = Object.keys(files.en).filter((file) => file !== 'blockly') as WordsFile[]
await fetchWords(...all)
for (const locale of [...language.all, 'en'] as const) await language.speak(locale)
