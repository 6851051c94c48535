import { askingRoutes } from './asking/routes.ts'
import { galleryPupilRoutes } from './gallery/pupil-routes.ts'
import { galleryTeacherRoutes } from './gallery/teacher-routes.ts'
import { livePupilRoutes } from './live/pupil-routes.ts'
import { liveTeacherRoutes } from './live/teacher-routes.ts'
import { joiningRoutes } from './joining/routes.ts'
import { answerRoutes } from './questionnaires/answer-routes.ts'
import { questionnaireRoutes } from './questionnaires/routes.ts'
import { tokenRoutes } from './questionnaires/token-routes.ts'
import { projectRoutes } from './projects/routes.ts'
import type { Method, Route } from './route.ts'
import { accountRoutes } from './teaching/account-routes.ts'
import { classRoutes } from './teaching/class-routes.ts'
import { clockRoutes } from './teaching/clock-routes.ts'
import { dataRoutes } from './teaching/data-routes.ts'
import { rehearsalRoutes } from './teaching/rehearsal-routes.ts'
import { resultRoutes } from './teaching/results-routes.ts'
import { substituteRoutes } from './teaching/substitute-routes.ts'
import { pupilRoutes } from './teaching/pupil-routes.ts'
import { togetherRoutes } from './together/routes.ts'
import { teacherRoutes } from './teaching/teacher-routes.ts'
import { wifiRoutes } from './teaching/wifi-routes.ts'

/** Who may ask what: the one table, which the router follows and the tests walk. */
export const routes: readonly Route[] = [
  ...accountRoutes,
  ...teacherRoutes,
  ...joiningRoutes,
  ...projectRoutes,
  ...classRoutes,
  ...pupilRoutes,
  ...livePupilRoutes,
  ...liveTeacherRoutes,
  ...substituteRoutes,
  ...wifiRoutes,
  ...resultRoutes,
  ...dataRoutes,
  ...clockRoutes,
  ...questionnaireRoutes,
  ...tokenRoutes,
  ...answerRoutes,
  ...rehearsalRoutes,
  ...galleryPupilRoutes,
  ...galleryTeacherRoutes,
  ...askingRoutes,
  ...togetherRoutes,
]

export interface Found {
  readonly route: Route
  readonly at: { readonly [name: string]: string }
}

const partsOf = (path: string) => path.split('/').slice(1)

/** What `:name` of a pattern stands for in a path; null where the path is another one. */
function matched(pattern: readonly string[], path: readonly string[]): Found['at'] | null {
  if (pattern.length !== path.length) return null
  const at: Record<string, string> = {}
  for (const [index, part] of pattern.entries()) {
    const given = path[index]!
    if (!part.startsWith(':')) {
      if (part !== given) return null
    } else if (/^[\w-]{1,64}$/.test(given)) at[part.slice(1)] = given
    else return null
  }
  return at
}

/** The route of a request below `/api/class`; else the methods that its path has: none for a path that is none of ours. */
export function findRoute(method: string, path: string): Found | readonly Method[] {
  const parts = partsOf(path)
  const others: Method[] = []
  for (const route of routes) {
    const at = matched(partsOf(route.path), parts)
    if (at && route.method === method) return { route, at }
    if (at) others.push(route.method)
  }
  return others
}
