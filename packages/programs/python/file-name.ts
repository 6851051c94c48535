import { validName } from './names.ts'

/** `NAME.py` for a project: a name that every system takes. */
export const fileName = (name: string): string =>
  `${validName(name.toLowerCase()).replace(/_$/, '').slice(0, 60) || 'robot'}.py`
