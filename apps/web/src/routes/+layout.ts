import { redirect } from '@sveltejs/kit'
import { resolve } from '$app/paths'
import { studyIsOn } from '#storage/study-sign.ts'
import { fetchWords } from '#words/message.ts'
import type { LayoutLoad } from './$types'

// The lab lives in the browser; pages are shells that start with the network cable pulled.
export const ssr = false
export const prerender = true
// A web space answers with the index.html of a folder, and only with that.
export const trailingSlash = __WEB_SPACE__ ? 'always' : 'never'

/** Pages that no study leaves open: what is done there stands in no log, and home and projects show those of all children. */
const closedInStudy = [
  '/',
  '/cards',
  '/maps',
  '/open',
  '/projects',
  '/projects/bin',
  '/race',
  '/sorting',
  '/zoo',
]

export const load: LayoutLoad = ({ route }) => {
  // Reading the route first makes this run for every page, not only where a study was on when the first one was loaded.
  const isClosed = closedInStudy.includes(route.id ?? '')
  if (isClosed && studyIsOn()) redirect(307, resolve('/study'))
  return fetchWords('app')
}
