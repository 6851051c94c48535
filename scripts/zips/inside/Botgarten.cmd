@echo off
rem Starts the lab and its class server. Closing this window stops both.
chcp 65001 >nul
title Botgarten
if not exist "%~dp0app\complete" goto packed
if not defined BOTGARTEN_DATA set "BOTGARTEN_DATA=%LOCALAPPDATA%\Botgarten"
set "NODE_COMPILE_CACHE=%BOTGARTEN_DATA%\cache"
if "%~1"=="" goto serve
"%~dp0node\node.exe" "%~dp0app\apps\cli\botgarten.js" %*
exit /b %errorlevel%

:serve
"%~dp0node\node.exe" --max-semi-space-size=2 --optimize-for-size "%~dp0app\apps\cli\botgarten.js" serve --open
if errorlevel 1 pause
exit /b

:packed
echo This folder is not complete. Unpack the whole zip first, then start Botgarten.cmd in its folder. Is the disk full?
echo Der Ordner ist nicht vollständig. Erst das ganze Zip entpacken, dann Botgarten.cmd darin starten. Ist die Platte voll?
pause
exit /b 1
