import type { IconName } from '#parts/icons.ts'
import { m } from '#words/message.ts'
import type { ClassInFull } from './answers.ts'
import { sayDay } from './ends.ts'

interface KeptRow {
  readonly id: string
  readonly icon: IconName
  readonly title: string
  readonly text: string
  readonly much: string
  readonly until: string
}

/** How many nightly backups are kept. */
export const backupNights = 7

/** What the server keeps of a class, a line each. */
export function keptOf(
  { pupils, projects, versions, endsOn }: ClassInFull,
  locale: string,
): readonly KeptRow[] {
  const until = sayDay(endsOn, locale)
  return [
    {
      ...{ id: 'pupils', icon: 'person', until },
      title: m['teacher.keptPupils'](),
      text: m['teacher.keptPupilsText'](),
      much: m['teacher.countPupils']({ count: pupils }),
    },
    {
      ...{ id: 'projects', icon: 'tidy', until },
      title: m['teacher.keptProjects'](),
      text: m['teacher.keptProjectsText'](),
      much: m['teacher.countProjects']({ count: projects }),
    },
    {
      ...{ id: 'versions', icon: 'reset', until },
      title: m['teacher.keptVersions'](),
      text: m['teacher.keptVersionsText'](),
      much: m['teacher.countVersions']({ count: versions }),
    },
    {
      ...{ id: 'live', icon: 'eye' },
      title: m['teacher.keptLive'](),
      text: m['teacher.keptLiveText'](),
      much: m['teacher.nothing'](),
      until: m['teacher.lessonEnd'](),
    },
    {
      ...{ id: 'backups', icon: 'database' },
      title: m['teacher.keptBackups'](),
      text: m['teacher.keptBackupsText'](),
      much: m['teacher.countBackups']({ count: backupNights }),
      until: m['teacher.eachNights']({ count: backupNights }),
    },
  ]
}
