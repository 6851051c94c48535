// One process that serves the lab and the class: the class's routes with a real clock, disk and database.
export { addresses } from './addresses.ts'
export { openClassServer, writeLink, type ClassOptions, type ClassServer } from './class-server.ts'
export { resetTeacher } from './reset.ts'
export { prepareDataFolder } from './data-folder.ts'
export { lockFolder } from './lock.ts'
export { CannotServe, causeIn } from './problem.ts'
export { inRepository } from './repository.ts'
export { startServer, type RunningServer, type ServerOptions } from './server.ts'
