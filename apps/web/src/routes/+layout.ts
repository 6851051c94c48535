import { fetchWords } from '#words/message.ts'

// The lab lives in the browser; pages are shells that start with the network cable pulled.
export const ssr = false
export const prerender = true
// A web space answers with the index.html of a folder, and only with that.
export const trailingSlash = __WEB_SPACE__ ? 'always' : 'never'

export const load = () => fetchWords('app')
