// For the tests: every language can be spoken at once.
import { language } from './language.svelte.ts'
import { fetchWords } from './say.ts'

await Promise.all(language.all.map((locale) => fetchWords(locale)))
