// For the tests: every language can be spoken at once.
import { language } from './language.svelte.ts'
import { fetchExpertWords, fetchHelp, fetchLateWords, fetchSortingWords, fetchWords } from './say.ts'

await Promise.all([fetchWords(), fetchLateWords(), fetchSortingWords(), fetchExpertWords(), fetchHelp()])
for (const locale of [...language.all, 'en'] as const) await language.speak(locale)
