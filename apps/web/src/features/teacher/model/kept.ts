import type { IconName } from '#parts/icons.ts'
import { m } from '#words/message.ts'
import type { Data } from './answers.ts'
import { dayLabel } from './ends.ts'

export interface KeptRow {
  readonly id: string
  readonly icon: IconName
  readonly title: string
  readonly text: string
  readonly much: string
  readonly until: string
}

function backupsLabel(backups: Data['backups']): string {
  if (backups === null) return m['teacher.byOwnTools']()
  return backups.count === 0 ? m['teacher.noneYet']() : m['teacher.countBackups']({ count: backups.count })
}

function backupRow({ backups }: Data): KeptRow {
  return {
    ...{ id: 'backups', icon: 'server' },
    title: m['teacher.keptBackups'](),
    text: m['teacher.keptBackupsText'](),
    much: backupsLabel(backups),
    until: m['teacher.untilBackups'](),
  }
}

/** What the server keeps of a class, a line each. */
export function keptOf(data: Data, locale: string): readonly KeptRow[] {
  const until = dayLabel(data.endsOn, locale)
  return [
    {
      ...{ id: 'pupils', icon: 'person', until },
      title: m['teacher.keptPupils'](),
      text: m['teacher.keptPupilsText'](),
      much: m['teacher.countPupils']({ count: data.pupils }),
    },
    {
      ...{ id: 'projects', icon: 'tidy', until },
      title: m['teacher.keptProjects'](),
      text: m['teacher.keptProjectsText'](),
      much: m['teacher.countProjects']({ count: data.projects }),
    },
    {
      ...{ id: 'versions', icon: 'reset', until },
      title: m['teacher.keptVersions'](),
      text: m['teacher.keptVersionsText'](),
      much: m['teacher.countVersions']({ count: data.versions }),
    },
    {
      ...{ id: 'shared', icon: 'share', until },
      title: m['teacher.keptShared'](),
      text: m['teacher.keptSharedText'](),
      much: m['teacher.countShared']({ count: data.shared }),
    },
    {
      ...{ id: 'results', icon: 'check', until },
      title: m['teacher.keptResults'](),
      text: m['teacher.keptResultsText'](),
      much: m['teacher.countResults']({ count: data.results }),
    },
    {
      ...{ id: 'forms', icon: 'bars', until },
      title: m['teacher.keptForms'](),
      text: m['teacher.keptFormsText'](),
      much: m['teacher.countForms']({ count: data.forms }),
    },
    backupRow(data),
  ]
}
